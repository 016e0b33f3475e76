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
