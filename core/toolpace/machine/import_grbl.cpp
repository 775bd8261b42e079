#include <string>

#include "toolpace/machine/importer.h"
#include "toolpace/machine/read_machine.h"
#include "toolpace/machine/settings_text.h"

namespace toolpace {
Result<Setup> import_grbl_dump(std::string_view text, const std::string& name) {
  Importer importer(read_grbl_values(text), name);
  importer.take("lookahead", "junction_deviation_mm", {"$11"}, 1.0);
  if (importer.find("$11")) importer.setup().options.corner.rule = CornerRule::junction;
  for (std::size_t k = 0; k < 3; ++k) {
    const std::string digit = std::to_string(k), section = std::string("axes.") + kAxisNames[k];
    importer.take(section, "steps_per_mm", {"$10" + digit}, 1.0);
    importer.take(section, "max_speed_mm_s", {"$11" + digit}, kPerMinute);
    importer.take(section, "max_acceleration_mm_s2", {"$12" + digit}, 1.0);
    const auto travel = importer.take("$13" + digit, 1.0);
    if (travel && *travel != 0) importer.set_travel(k, -*travel, 0.0);
  }
  return importer.finish("grbl's answer to $$");
}

}  // namespace toolpace
