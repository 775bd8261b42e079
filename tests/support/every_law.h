#pragma once
/// For tests that run once a row of the law table.

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "toolpace/law/law_table.h"

namespace toolpace::test {

inline std::vector<LawKind> every_law() {
  std::vector<LawKind> kinds;
  for (const LawRow& row : law_table()) kinds.push_back(row.kind);
  return kinds;
}

/// The law's id, as a test may be called.
inline std::string law_name(const ::testing::TestParamInfo<LawKind>& row) {
  std::string name(law_row(row.param).id);
  std::replace(name.begin(), name.end(), '-', '_');
  return name;
}

}  // namespace toolpace::test
