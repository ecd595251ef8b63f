// What stands between a text frame and who serves it.
#include "face/server/hub/internal/command_gate.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "face/server/hub/internal/answers.hpp"

namespace kerf::server {
namespace {

struct Connection : Link {
  void wake() override {}
  void close(Why /*why*/, const std::string& /*sentence*/) override {}
};

class Gate : public testing::Test {
 protected:
  std::optional<CommandGate::Admitted> admit(const std::string& text) {
    return gate_.admit(client_, text);
  }
  /// What the client has been told last; empty: nothing since.
  std::string told() {
    std::string last;
    while (auto message = client_->next()) last = message->bytes;
    return last;
  }

  Connection connection_;
  std::shared_ptr<Client> client_ = std::make_shared<Client>("client-1", connection_);
  ServerClock clock_;
  CommandGate gate_{clock_};
};

TEST_F(Gate, LetsACommandOfTheTableThroughWithItsArguments) {
  const auto command = admit(R"({"id":1,"do":"introduce","name":"Lee"})");
  ASSERT_TRUE(command);
  EXPECT_EQ(command->command->name, "introduce");
  EXPECT_EQ(command->request.arguments().text("name"), "Lee");
  EXPECT_EQ(told(), "");
}

TEST_F(Gate, TellsByItsIdWhyACommandIsRefused) {
  const std::vector<std::pair<std::string, std::string>> rows = {
      {"nonsense", "a command is an object of JSON, and this is none"},
      {R"({"id":7})", "the command names nothing to do"},
      {R"({"id":7,"do":"fly"})", "there is no command fly"},
      {R"({"id":7,"do":"introduce","name":5})", "introduce: name"},
      {R"({"id":7,"do":"ping","at_ms":"now"})", "ping: at_ms must be a number"},
      {R"({"id":7,"do":"ping","at_ms":-3000})", "\"code\":\"command-late\""},
      {R"({"id":7,"do":"cycle-start"})", "no machine is watched on this connection"}};
  for (const auto& [text, sentence] : rows) {
    EXPECT_FALSE(admit(text)) << text;
    const std::string answer = told();
    EXPECT_NE(answer.find(sentence), std::string::npos) << answer;
    EXPECT_NE(answer.find(text == "nonsense" ? "\"id\":null" : "\"id\":7"), std::string::npos);
  }
}

TEST_F(Gate, HasSoManyCommandsOfAClientUnderWay) {
  std::vector<CommandGate::Admitted> under_way;
  for (std::size_t i = 0; i < limits::kUnderWay; ++i)
    under_way.push_back(*admit(R"({"do":"machines"})"));
  EXPECT_FALSE(admit(R"({"do":"machines"})"));
  EXPECT_NE(told().find("\"code\":\"under-way\""), std::string::npos);
  under_way.back().request.reply.yes();
  EXPECT_TRUE(admit(R"({"do":"machines"})"));
}

TEST_F(Gate, RefusesHaste) {
  constexpr int kMany = 2 * limits::kCommandBurst;
  std::string last;
  for (int i = 0; i < kMany && last.find("\"code\":\"too-fast\"") == std::string::npos; ++i) {
    static_cast<void>(admit("{}"));
    last = told();
  }
  EXPECT_NE(last.find("\"code\":\"too-fast\""), std::string::npos) << last;
}

TEST(Answers, NameTheDataFolderInNoSentence) {
  const Answers answers([](const std::function<void()>& action) { action(); }, "/data/kerf");
  EXPECT_EQ(answers.without_folder("/data/kerf/library/a.nc: /data/kerf/machines is full"),
            "library/a.nc: machines is full");
}

}  // namespace
}  // namespace kerf::server
