// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <set>
#include <string>
#include <tools/live/gate.hpp>

using namespace trophic;

namespace {

const std::string token(32, 'a');

struct Case {
  live::Request request;
  unsigned status;  // 0: let in
};

}  // namespace

TEST_CASE("live gate: own page and its web socket -> let in, others -> refused in one sentence") {
  const std::string page = "/?token=" + token;
  const std::string socket = "/live?token=" + token;
  const std::string own = "http://localhost:8000";
  const std::string longer = page + "b";
  const std::string second = "/?x=1&token=" + token;
  for (const Case& one : {
           Case{{"GET", page, "127.0.0.1:4000", "", false}, 0},
           Case{{"GET", page, "localhost:8000", "", false}, 0},
           Case{{"GET", page, "[::1]:4000", "", false}, 0},
           Case{{"GET", socket, "localhost:8000", own, true}, 0},
           Case{{"POST", page, "127.0.0.1:4000", "", false}, 405},
           Case{{"OPTIONS", page, "127.0.0.1:4000", "", false}, 405},
           Case{{"GET", page, "evil.example:4000", "", false}, 403},
           Case{{"GET", page, "localhost.evil.example", "", false}, 403},
           Case{{"GET", page, "127.0.0.1:4000.evil.example", "", false}, 403},
           Case{{"GET", page, "", "", false}, 403},
           Case{{"GET", "/", "localhost:8000", "", false}, 403},
           Case{{"GET", longer, "localhost:8000", "", false}, 403},
           Case{{"GET", second, "localhost:8000", "", false}, 403},
           Case{{"GET", socket, "localhost:8000", "", false}, 404},
           Case{{"GET", page, "localhost:8000", own, true}, 404},
           Case{{"GET", socket, "localhost:8000", "", true}, 403},
           Case{{"GET", socket, "localhost:8000", "null", true}, 403},
           Case{{"GET", socket, "localhost:8000", "https://localhost:8000", true}, 403},
           Case{{"GET", socket, "localhost:8000", "http://localhost:8001", true}, 403},
           Case{{"GET", socket, "localhost:8000", "http://evil.example", true}, 403},
       }) {
    CAPTURE(one.request.method);
    CAPTURE(one.request.target);
    CAPTURE(one.request.host);
    CAPTURE(one.request.origin);
    const auto refusal = live::refusal_of(one.request, token);
    CHECK((refusal ? refusal->status : 0U) == one.status);
    if (refusal) CHECK(refusal->sentence.find('\n') == std::string::npos);
  }
}

TEST_CASE("live gate: new tokens -> 32 hexadecimal digits, all different") {
  std::set<std::string> tokens;
  for (int i = 0; i < 100; ++i) tokens.insert(live::new_token());
  CHECK(tokens.size() == 100);
  for (const std::string& one : tokens) {
    CHECK(one.size() == 32);
    CHECK(one.find_first_not_of("0123456789abcdef") == std::string::npos);
  }
}
