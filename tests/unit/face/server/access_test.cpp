#include "face/server/transport/access.hpp"

#include <gtest/gtest.h>

namespace kerf::server {
namespace {

const Address kOpen{"127.0.0.1", 8080};
const Address kGuarded{"0.0.0.0", 8080, "a-secret-of-plant"};

Refusal verdict(const Address& address, const Visit& visit) {
  const Verdict verdict = admit(address, visit);
  EXPECT_EQ(verdict.sentence.empty(), verdict.refusal == Refusal::none);
  return verdict.refusal;
}

TEST(Access, AnAddressThatOthersReachNeedsAToken) {
  EXPECT_TRUE(check_address({"localhost", 1}));
  EXPECT_TRUE(check_address({"::1", 1}));
  EXPECT_FALSE(check_address({"0.0.0.0", 1}));
  EXPECT_FALSE(check_address({"192.168.1.5", 1}));
  EXPECT_FALSE(check_address({"127.0.0.1.evil.example", 1}));
  EXPECT_TRUE(check_address(kGuarded));
  EXPECT_FALSE(check_address({"0.0.0.0", 1, "fifteen-letters"}));
  EXPECT_FALSE(check_address({"0.0.0.0", 1, "with blank and more"}));
  EXPECT_FALSE(check_address({"0.0.0.0", 1, "a&b=c#d;e/f"}));
}

TEST(Access, WithoutATokenTheHostIsThisComputer) {
  for (const char* host :
       {"localhost", "localhost:8080", "LOCALHOST:1", "127.0.0.1:8080", "[::1]:8080"})
    EXPECT_EQ(verdict(kOpen, {host, "", "", "/"}), Refusal::none) << host;
  for (const char* host :
       {"", "evil.example", "localhost.evil.example:8080", "127.0.0.1.evil.example", "[::1",
        "[::1]evil", "[::1]evil:80", "localhost@evil.example"})
    EXPECT_EQ(verdict(kOpen, {host, "", "", "/"}), Refusal::forbidden) << host;
}

TEST(Access, AnOriginIsTheHostThatWasAskedFor) {
  const auto from = [](const char* origin) {
    return verdict(kOpen, {"localhost:8080", origin, "", "/ws"});
  };
  EXPECT_EQ(from("http://localhost:8080"), Refusal::none);
  EXPECT_EQ(from("https://localhost:8080"), Refusal::none);
  for (const char* origin :
       {"http://localhost", "http://localhost:8081", "http://evil.example", "null",
        "http://localhost:8080.evil.example", "file://", "localhost:8080"})
    EXPECT_EQ(from(origin), Refusal::forbidden) << origin;
}

TEST(Access, TheTokenComesInTheAddressOrInTheCookie) {
  const auto by = [](const char* target, const char* cookie) {
    return verdict(kGuarded, {"plant.example:8080", "", cookie, target});
  };
  EXPECT_EQ(by("/ws?token=a-secret-of-plant", ""), Refusal::none);
  EXPECT_EQ(by("/?a=1&token=a-secret-of-plant", ""), Refusal::none);
  EXPECT_EQ(by("/", "x=1; kerf_token=a-secret-of-plant"), Refusal::none);
  for (const char* target : {"/", "/?token=", "/?token=secret", "/?token=a-secret-of-plant2",
                             "/?xtoken=a-secret-of-plant", "/a-secret-of-plant",
                             "/?token=A-SECRET-OF-PLANT", "/?token=%"})
    EXPECT_NE(by(target, ""), Refusal::none) << target;
  for (const char* cookie :
       {"kerf_token=", "xkerf_token=a-secret-of-plant", "kerf_token2=a-secret-of-plant"})
    EXPECT_NE(by("/", cookie), Refusal::none) << cookie;
  EXPECT_EQ(by("/", ""), Refusal::no_token);
  EXPECT_EQ(by("/?token=guess", ""), Refusal::wrong_token);
  EXPECT_EQ(by("/", "kerf_token=guess"), Refusal::wrong_token);
}

TEST(Access, PercentEscapesAreResolvedOrRefused) {
  EXPECT_EQ(unescaped("a%20b%2Fc"), "a b/c");
  EXPECT_EQ(unescaped("plain+"), "plain+");
  for (const char* wrong : {"%", "a%2", "%zz", "%0x"})
    EXPECT_EQ(unescaped(wrong), std::nullopt) << wrong;
}

}  // namespace
}  // namespace kerf::server
