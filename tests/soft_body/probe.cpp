#pragma GCC diagnostic ignored "-Wconversion"
#pragma GCC diagnostic ignored "-Wsign-conversion"
#pragma GCC diagnostic ignored "-Wold-style-cast"
#pragma GCC diagnostic ignored "-Wnarrowing"
#pragma GCC diagnostic ignored "-Wfloat-conversion"
#include <gtest/gtest.h>
#include <cstdio>
#include <chrono>
#include <cmath>
#include <glm/vec3.hpp>
#include "gpu/gpu_fixture.h"
#include "gpu/helpers.h"
#include "opaline/scene.h"
#include "passes/soft_body/soft_body_pass.h"
#include "soft_body/dynamics.h"
namespace opaline { namespace {
class P : public gpu::GpuTest {};
double volume(const std::vector<float>& p, const std::vector<Triangle>& t){ double s=0; for(auto&q:t){double a[3],b[3],c[3];for(int i=0;i<3;i++){a[i]=p[3*q[0]+i];b[i]=p[3*q[1]+i];c[i]=p[3*q[2]+i];} s+=a[0]*(b[1]*c[2]-b[2]*c[1])+a[1]*(b[2]*c[0]-b[0]*c[2])+a[2]*(b[0]*c[1]-b[1]*c[0]);} return s/6;}
TEST_F(P, Bear) {
  const char* cs=getenv("CELLS"); int cells= cs?atoi(cs):12;
  Scene scene = builtInBear();
  auto& mesh = scene.objects[0].mesh;
  auto t0=std::chrono::steady_clock::now();
  soft_body::Cage cage = soft_body::makeCage(mesh.positionsMm, mesh.triangles, cells, 0.06, 1360);
  auto t1=std::chrono::steady_clock::now();
  auto d = soft_body::makeDynamics(cage, {});
  passes::SoftBodyPass pass(device());
  auto s = passes::SoftBodyPass::makeState(device(), cage, mesh.positionsMm);
  auto t2=std::chrono::steady_clock::now();
  Bounds b=boundsOf(scene);
  printf("cells %zu nodes %zu counts %u %u %u cell %g mm, 1/h %g shear %g compl %g grip %g cage ms %g state ms %g\n box %g %g %g..%g %g %g\n", cage.cells.size(), cage.nodes.size(), cage.counts[0],cage.counts[1],cage.counts[2],cage.cellMm,1/d.substepSeconds,d.shear,d.compliance,d.grip, std::chrono::duration<double>(t1-t0).count()*1e3,std::chrono::duration<double>(t2-t1).count()*1e3, b.minMm[0],b.minMm[1],b.minMm[2],b.maxMm[0],b.maxMm[1],b.maxMm[2]);
  gpu::CommandList list(device(), "probe", 4);
  shared::SoftStep st{};
  st.shear=d.shear; st.compliance=d.compliance; st.anchor=d.anchor; st.grip=d.grip; st.damping=d.damping; 
  float diag=diagonalMm(scene)/cage.cellMm; st.reach=0.6f*diag; st.stillStep=1e-3f*diag*d.substepSeconds; st.stillShift=1e-4f*diag;
  int per = std::round(0.1/d.substepSeconds);
  if (getenv("FPS")) per = std::round(1/atof(getenv("FPS"))/d.substepSeconds);
  st.substeps=per;
  double v0 = volume(gpu::readAs<float>(device(), s.positions), mesh.triangles);
  // grab ear/top
  Vec3 at=mesh.positionsMm[0]; for(auto&p:mesh.positionsMm) if(p[1]>at[1]) at=p;
  int frames = 4.0/(per*d.substepSeconds);
  double worst=0;
  for(int f=0;f<frames;f++){
    double time=f*per*d.substepSeconds;
    if(f==0){ for(int i=0;i<3;i++) st.grab[i]=(at[i]-cage.originMm[i])/cage.cellMm; st.grab.w=1/2.8f; st.holds=1; } else st.grab.w=0;
    double pull=0.4*diag; 
    st.goal={pull*0.8f,pull*0.6f,0,d.follow};
    if(time>1) st.holds=0;
    list.begin(); pass.swing(list,st,s); pass.embed(list,s); list.submit(); list.wait();
    auto p=gpu::readAs<float>(device(), s.positions);
    double mx=0; bool fin=true; for(size_t v=0;v<p.size();v++){ fin&=std::isfinite(p[v]); double q=p[v]-mesh.positionsMm[v/3][v%3]; mx=std::max(mx,std::abs(q)); }

    double vol=volume(p,mesh.triangles)/v0-1; worst=std::max(worst,std::abs(vol));
    if (f%std::max(1,int(0.1/(per*d.substepSeconds)))==0) printf("t %.2f max shift %.3f mm vol %+.3f%% finite %d still %u  swing %.3f ms embed %.3f\n", time, mx, 100*vol, fin, gpu::readAs<shared::SoftReport>(device(),s.report)[0].still, list.timings()[0].milliseconds, list.timings()[1].milliseconds);
  }
  printf("worst vol %.3f%%\n",100*worst);
}
}}
