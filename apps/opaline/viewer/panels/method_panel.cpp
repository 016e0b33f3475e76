#include <imgui.h>

#include <string>

#include "cli/picture_options.h"
#include "viewer/panels/controls.h"
#include "viewer/panels/option_control.h"
#include "viewer/panels/panels.h"

namespace opaline::app::viewer {

namespace {

bool drawPattern(RenderOptions& options) {
  bool changed = drawOption("near rings", options, "near_rings",
                            "The near block has (2 n + 1) squared samples. Gong et al. 2008, "
                            "Figure 5.");
  changed |= drawOption("near spacing", options, "near_spacing",
                        "Between near samples, in mean free paths of the channel where they are "
                        "shortest.");
  changed |= drawOption("far distance", options, "far_distance",
                        "Of the eight far samples, in mean free paths.");
  return changed;
}

bool drawBoundary(RenderOptions& options) {
  bool changed = drawOption("bounces", options, "bounces",
                            "How often light may leave the body and enter it again.");
  static const Choices<int> most{{"2048", 2048}, {"4096", 4096}, {"8192", 8192}, {"16384", 16384}};
  changed |=
      controls::choice("clusters", options.maxClusters, most,
                       "Largest number of unknowns on the body's surface. Thin parts need many.");
  return changed;
}

}  // namespace

void drawMethodPanel(Session& session) {
  if (!controls::section("Method", false)) return;
  RenderOptions& options = session.options;
  bool changed = drawOption(
      "transport", options, "transport",
      "How light travels in the body: boundary solves diffusion on the body as it is; the dipoles "
      "treat every place as part of an endless flat slab (Jensen et al. 2001; d'Eon 2012).");
  // Boundary transport and the pattern exclude each other: the last choice wins.
  if (changed && options.transport == Transport::Boundary && options.sum == Sum::Pattern) {
    options.sum = Sum::Tree;
  }
  if (drawOption("sum", options, "sum",
                 "The sources that are summed: a tree of surfels within the tolerance, all "
                 "surfels, or the pattern of Gong et al. 2008.")) {
    changed = true;
    if (options.sum == Sum::Pattern && options.transport == Transport::Boundary) {
      options.transport = Transport::Dipole;
    }
  }
  changed |= drawOption("site", options, "site",
                        "Where light is summed: at vertices, at pixels, or at vertices where "
                        "edges are no longer than a mean free path.");
  if (options.sum == Sum::Tree) {
    changed |= drawOption("tolerance", options, "tolerance",
                          "Allowed error of a group of sources, relative to the exitance.");
  }
  if (options.transport == Transport::Boundary) {
    changed |= drawBoundary(options);
    controls::checkbox("quick while moving", session.quickWhileMoving,
                       "Uses a tolerance of 0.05 while light, medium or body move, if this device "
                       "needs more than 150 ms for boundary transport.");
  }
  if (options.transport != Transport::Boundary)
    changed |= drawOption("ambient occlusion", options, "ambient_occlusion",
                          "Hides the sky where something stands before it. Boundary transport "
                          "always does.");
  if (options.sum == Sum::Pattern) changed |= drawPattern(options);
  if (controls::button("Gong et al. 2008", "The paper's method: dipole, pattern, fragment.")) {
    options = paperOptions(options);
    changed = true;
  }
  const std::string complaint = complaintAboutPattern(session.scene);
  ImGui::BeginDisabled(!complaint.empty() && !session.divided);
  changed |= controls::checkbox(
      "compare with the paper", session.divided,
      complaint.empty() ? "Shows the paper's method on the left of a divider that you can drag."
                        : complaint.c_str());
  ImGui::EndDisabled();
  // Which indices can be shown depends on the method.
  const bool shown = session.surfelIndex == SurfelIndex::Cluster
                         ? options.transport == Transport::Boundary
                         : options.sum != Sum::Pattern;
  if (session.aov == Aov::Surfels && !shown) session.aov = Aov::Radiance;
  if (changed) session.edits.picture = true;
}

}  // namespace opaline::app::viewer
