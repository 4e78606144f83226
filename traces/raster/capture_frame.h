#pragma once
/// What every kind of capture begins with: the light's grid, pass 1, and the header.
#include "traces/raster/fragments.h"

namespace kagesen {

struct CaptureFrame {
  /// Throws UserError for a scene or options that cannot be captured.
  CaptureFrame(const Scene& scene, const CaptureOptions& options);
  /// begin() and casters(). Change the header before, not after.
  void send_casters(TraceSink& sink) const;

  const Scene& scene;
  LightSpace space;
  CasterSet casters;
  TraceHeader header;
  CaptureSummary summary;  ///< pass 1 filled in
};

}  // namespace kagesen
