// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <span>
#include <sstream>
#include <string>
#include <tools/analysis/report/ablation_tables.hpp>
#include <trophic/io/csv.hpp>
#include <unit/analysis/swap_sets.hpp>
#include <vector>

using namespace trophic;
using namespace trophic::analysis;
using test::base;
using test::set_around;

TEST_CASE("the table has what is significant and nothing else") {
  auto effects = effects_of("wide", compare_sets(base, {set_around(0.5, 12.0), base.shadow}));
  adjust_together(effects);
  std::ostringstream out;
  print_significant(out, effects);
  CHECK(out.str().find("| wide | hunger predator | 10.0 | 12.0 | +2.0 [") != std::string::npos);
  CHECK(out.str().find("attribution") == std::string::npos);
}

TEST_CASE("shares: swaps into the first table, and out of the second with the sign turned, and what is lacking has no sum") {
  const ShadowedSet second{set_around(0.5, 14.0), base.shadow};
  const auto effects = [](const std::string& swap, const ShadowedSet& from, double hunger) {
    auto found = effects_of(swap, compare_sets(from, {set_around(0.5, hunger), base.shadow}));
    adjust_together(found);
    return found;
  };
  const auto whole = effects("second", base, 14.0);
  std::vector<SwapEffect> forward = effects("a", base, 11.0);
  for (const auto& effect : effects("b", base, 12.0)) forward.push_back(effect);
  std::vector<SwapEffect> backward = effects("a", second, 12.5);
  const std::vector<std::string> names{"a", "b"};
  std::ostringstream out;
  print_shares(out, whole, forward, backward, names);
  CHECK(out.str().find("| +1.0* | +1.5* | +2.0* | missing | +3.0 | missing |") != std::string::npos);
  CHECK(out.str().find("attribution") == std::string::npos);
}

TEST_CASE("ablations.csv has a row an effect, significant or not") {
  auto effects = effects_of("wide", compare_sets(base, {set_around(0.5, 12.0), base.shadow}));
  adjust_together(effects);
  std::vector<SwapRow> rows;
  for (const SwapEffect& effect : effects) rows.push_back(row_of(effect, "from_paper"));
  CHECK(rows[0].compared == "over_shadow");
  CHECK(rows[0].significant == "no");
  CHECK(rows[1].significant == "yes");
  effects[1].difference.adjusted.reset();
  CHECK(row_of(effects[1], "from_paper").significant.empty());
  const std::string text = io::table_text(std::span<const SwapRow>{rows});
  CHECK(
      text.starts_with("swap,direction,metric,species,group,unit,compared,runs_base,runs_swapped,base,swapped,difference,lower,"
                       "upper,p,p_holm,significant\nwide,from_paper,attribution_caught,prey,all,1,over_shadow,6,6,"));
}
