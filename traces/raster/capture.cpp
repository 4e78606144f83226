#include "traces/raster/capture.h"

#include "traces/raster/capture_frame.h"
#include "traces/raster/checks.h"

namespace kagesen {

CaptureFrame::CaptureFrame(const Scene& scene_in, const CaptureOptions& options)
    : scene(scene_in), space(fit_light_space(scene_in, options)) {
  if (options.progress) options.progress("casters", 0);
  casters = make_casters(scene, space);
  header.map_width = options.map_width;
  header.map_height = options.map_height;
  header.fraction_bits = space.fraction_bits;
  header.scale_x = options.scale_x;
  header.scale_y = options.scale_y;
  header.image_width = options.image_width;
  header.image_height = options.image_height;
  header.mode = options.mode;
  header.source = scene.name;
  header.source_sha256 = scene.sha256;
  header.light = describe_light(scene.light);
  header.seed = scene.seed;
  header.warnings = scene.warnings;
  for (const Object& object : scene.objects) {
    header.objects.push_back({object.name, static_cast<std::uint32_t>(object.triangles.size()),
                              object.closed, object.caster});
  }
  summary.casters = casters.casters.size();
  summary.culled = casters.culled;
  summary.degenerate = casters.degenerate;
  summary.clipped = casters.clipped;
}

void CaptureFrame::send_casters(TraceSink& sink) const {
  sink.begin(header);
  if (!casters.casters.empty()) sink.casters(casters.casters.data(), casters.casters.size());
}

CaptureSummary capture(const Scene& scene, const CaptureOptions& options, TraceSink& sink) {
  CaptureFrame frame(scene, options);
  frame.send_casters(sink);
  FragmentStream stream(sink, frame.summary);
  draw_samples(scene, options, frame.space, frame.casters,
               [&](const Sample& sample) { stream.push(sample.fragment); });
  stream.flush();
  sink.end();
  return frame.summary;
}

}  // namespace kagesen
