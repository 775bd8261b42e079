/// Marlin and other firmware of 3D printers.

#include "toolpace/nc/dialects/rules.h"

namespace toolpace::nc {

// Printers do not compare radii; what lies further off than this was meant otherwise.
constexpr ArcTolerance kMarlinArcs{
    .metric = 0.05, .inch = 0.05, .relative = 0.01, .most = 10.0, .least_radius = 0.0001};

const DialectRules kMarlinRules{.dialect = Dialect::marlin,
                                .sender_lines = true,
                                .line_checksums = true,
                                .extruder = true,
                                .ends_with_text = true,
                                .dwells_in_milliseconds = true,
                                .dwells_by_axis_words = true,
                                .machine_moves_incremental = true,
                                .ignores_centre_off_plane = true,
                                .arc = kMarlinArcs,
                                .g_code = sender_g_code,
                                .m_code = sender_m_code,
                                .unfollowed = nothing_unfollowed};

}  // namespace toolpace::nc
