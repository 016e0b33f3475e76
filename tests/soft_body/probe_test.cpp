#pragma GCC diagnostic ignored "-Wfloat-conversion"
#pragma GCC diagnostic ignored "-Wconversion"
#pragma GCC diagnostic ignored "-Wsign-conversion"
#include <gtest/gtest.h>
#include <cstdio>
#include <cmath>
#include "gpu/gpu_fixture.h"
#include "gpu/helpers.h"
#include "renderer/shapes.h"
#include "soft_body/bodies.h"
namespace opaline { namespace { using namespace test;
class P : public gpu::GpuTest {};
TEST_F(P, Open) {
  for (float off : {0.f, 1e6f}) {
  Mesh mesh = sheet({off, 5, 0}, {5, 0, 0}, {0, 5, 5});
  SoftBodyOptions o; o.cells=16;
  SoftBodyMotion body(device(), mesh.positionsMm, mesh.triangles, o);
  printf("cells %zu nodes %zu counts %u %u %u, cell %g 1/h %g shear %g compl %g grip %g anchor %g\n", body.cage().cells.size(), body.cage().nodes.size(), body.cage().counts[0],body.cage().counts[1],body.cage().counts[2],body.cage().cellMm,1/body.dynamics().substepSeconds,body.dynamics().shear,body.dynamics().compliance,body.dynamics().grip,body.dynamics().anchor);
  Field rest=positionsOf(body);
  Vec3 at=mesh.positionsMm[0]; for(auto&p:mesh.positionsMm) if(p[1]>at[1]) at=p;
  float cell=body.cage().cellMm;
  body.grab(at, cell); body.pull({at[0]+4*cell, at[1]+2*cell, at[2]});
  for(int i=0;i<300;i++){ if(i==20) body.release(); body.step(0.05);
    if(i%20==19){ auto n=nodesOf(body); double ms=0,mv=0; size_t w=0; for(size_t k=0;k<n.shift.size();k++){ double s=std::hypot(n.shift[k][0],n.shift[k][1],n.shift[k][2]); if(s>ms){ms=s;w=k;} mv=std::max(mv,std::hypot(n.step[k][0],n.step[k][1],n.step[k][2])); }
      printf("t %.2f shift %.5f cells at node %u %u %u  step %.3g energy %.5g far %.4f\n", (i+1)*.05, ms, body.cage().nodes[w][0],body.cage().nodes[w][1],body.cage().nodes[w][2], mv, energyOf(body), farthest(positionsOf(body),rest)); } }
  }
}
}}
namespace opaline { namespace {
TEST_F(P, Wave) {
  const Mesh mesh = bar(3, 12);
  SoftBodyOptions options;
  options.settleSeconds = 20;
  SoftBodyMotion body(device(), mesh.positionsMm, mesh.triangles, options);
  const soft_body::Cage& cage = body.cage();
  std::vector<shared::SoftMotion> motions;
  for (const auto& node : cage.nodes) {
    shared::SoftMotion motion{};
    motion.shiftY = static_cast<float>(0.02 * std::sin(M_PI / 24 * node[1]));
    motion.aheadY = motion.shiftY;
    motions.push_back(motion);
  }
  body.state().motions = gpu::makeBuffer(device(), "stretched", motions, VK_BUFFER_USAGE_STORAGE_BUFFER_BIT);
  body.grab({1000, 0, 0}, 0);
  printf("1/h %g tau2 %g\n", 1/body.dynamics().substepSeconds, body.dynamics().waveNumber);
  for (int i = 1; i < 500; ++i) { body.step(body.dynamics().substepSeconds*1.0001); if(i%10==1){ auto n=nodesOf(body); double t=0; int c=0; for(size_t k=0;k<n.shift.size();k++) if(cage.nodes[k][1]==12){t+=n.shift[k][1];c++;} printf("%d %.6f E %.4g\n", i, t/c, energyOf(body)); } }
}
}}
#include <Eigen/Dense>
namespace opaline { namespace {
void report(SoftBodyMotion& body, const Field& rest, const Mesh& mesh, double v0, double t) {
 auto n=nodesOf(body); int inv=0,badturn=0; double worst=9; auto turns=gpu::readAs<glm::vec4>(*gpu::sharedDevice().device, body.state().turns); size_t ci=0;
      for(auto&c:body.cage().cells){ Eigen::Matrix3d F=Eigen::Matrix3d::Zero(); for(unsigned k=0;k<8;k++) for(unsigned a=0;a<3;a++) { Eigen::Vector3d x; for(int b=0;b<3;b++) x[b]=body.cage().nodes[c[k]][b]+n.shift[c[k]][b]; F.col(a)+=((k>>a&1)?.25:-.25)*x; }
        double d=F.determinant(); worst=std::min(worst,d); if(d<0) inv++;
        auto q=turns[ci++]; Eigen::Quaterniond Q(q.w,q.x,q.y,q.z); Eigen::JacobiSVD<Eigen::Matrix3d> svd(F,Eigen::ComputeFullU|Eigen::ComputeFullV); Eigen::Matrix3d S=Eigen::Matrix3d::Identity(); S(2,2)=(svd.matrixU()*svd.matrixV().transpose()).determinant()<0?-1:1; Eigen::Matrix3d R=svd.matrixU()*S*svd.matrixV().transpose(); if((R-Q.toRotationMatrix()).norm()>0.05) badturn++; }
      printf("t %.1f far %.3f inverted %d worst det %.3f badturn %d E %.4g vol %.4f moves %d\n",t,farthest(positionsOf(body),rest),inv,worst,badturn,energyOf(body),volumeOf(positionsOf(body),mesh.triangles)/v0,body.moves()); }
TEST_F(P, Stuck) {
  Scene scene = builtInBear(); const Mesh& mesh=scene.objects[0].mesh;
  SoftBodyOptions o; if(getenv("REACH")) o.reach=atof(getenv("REACH")); if(getenv("CELLS")) o.cells=atoi(getenv("CELLS"));
  SoftBodyMotion body(device(), mesh.positionsMm, mesh.triangles, o);
  Field rest=positionsOf(body); double v0=volumeOf(rest,mesh.triangles);
  for (Vec3 to : {Vec3{30, 39, 0}, Vec3{0, 69, 0}, Vec3{-20, 20, 20}, Vec3{0, 9, 0}}) {
   body.grab({0,39,0},4); body.pull(to); double wv=0;
   for(int i=0;i<20;i++){ if(i==10) body.release(); body.step(0.1); wv=std::max(wv,std::abs(volumeOf(positionsOf(body),mesh.triangles)/v0-1)); if(i%5==4) report(body,rest,mesh,v0,(i+1)*.1); }
   printf("worst vol %.4f\n",wv);
  }
  for(int i=0;i<40;i++){ body.step(.1); if(i%10==9) report(body,rest,mesh,v0,i*.1); }
  FILE*f=fopen("/tmp/stuck.obj","w"); for(auto&p:positionsOf(body)) fprintf(f,"v %g %g %g\n",p[0],p[1],p[2]); for(auto&t:mesh.triangles) fprintf(f,"f %u %u %u\n",t[0]+1,t[1]+1,t[2]+1); fclose(f);
}
}}
