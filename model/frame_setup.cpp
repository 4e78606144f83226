#include "model/frame_setup.h"

#include <utility>

#include "model/facets.h"
#include "model/unit_ids.h"
#include "model/unshadowable.h"

namespace kagesen {

FrameSetup make_frame_setup(const Trace& trace, const UnitConfig& config,
                            std::uint64_t* aliased_objects) {
  FrameSetup setup;
  setup.fraction_bits = trace.header.fraction_bits;
  const bool winding = config.profile == Profile::kWinding;
  UnitIds units;
  if (!winding || config.semantics == Semantics::kPaper) {
    units = assign_unit_ids(trace, setup.fraction_bits, int(config.id_bits));
  }
  setup.unit_ids = std::move(units.ids);
  if (aliased_objects) *aliased_objects = units.sharing;
  if (!winding) return setup;

  FacetGroups groups = group_facets(trace.all_casters, setup.fraction_bits, config);
  setup.facets = std::move(groups.facets);
  setup.planes = std::move(groups.planes);
  if (config.skip_fragments) setup.unshadowable = find_unshadowable(trace, config);
  return setup;
}

}  // namespace kagesen
