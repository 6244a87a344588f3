// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <string>
#include <tools/experiment/escaped.hpp>

using namespace trophic;

TEST_CASE("escaped: special characters -> Markdown and LaTeX show them letter by letter") {
  const std::string odd = R"(50 % of "A & B" {$5} #1 a_b ^ ~ \ <c|d> *)";
  CHECK(markdown_text(odd) == R"(50 % of "A & B" {$5} #1 a\_b ^ \~ \\ \<c\|d\> \*)");
  CHECK(latex_text(odd) ==
        R"(50 \% of ``A \& B'' \{\$5\} \#1 a\_\allowbreak{}b \textasciicircum{} \textasciitilde{} \textbackslash{} )"
        R"(\textless{}c\textbar{}d\textgreater{} *)");
  CHECK(latex_text("a/b") == R"(a/\allowbreak{}b)");
  CHECK(markdown_text("plain") == "plain");
}
