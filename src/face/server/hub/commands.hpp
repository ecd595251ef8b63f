#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "face/server/protocol/json.hpp"
#include "machine/panel/operation_table.hpp"

namespace kerf::server {

/// Version of the protocol that docs/panel-protocol.md describes.
inline constexpr int kProtocol = 1;

/// Sizes, rates and counts that the server keeps, each refused with a sentence.
namespace limits {
inline constexpr std::size_t kTextBytes = 1'000'000;  ///< a program in a command
/// A WebSocket message to the server: such a program with each character escaped by a backslash.
inline constexpr std::size_t kMessageBytes = 2 * kTextBytes + (64U << 10U);
inline constexpr std::size_t kHeaderBytes = 16U << 10U;  ///< of an HTTP request
/// What the kernel holds of a connection's answers; it counts twice as much for them.
inline constexpr int kSocketBytes = 192 << 10;
/// Answers and events that wait for a client.
inline constexpr std::size_t kQueueBytes = 8U << 20U;
inline constexpr int kCommandsPerSecond = 200;  ///< of a connection, on average
inline constexpr int kCommandBurst = 400;
inline constexpr std::size_t kUnderWay =
    64;  ///< commands of a connection that are not answered yet
inline constexpr std::size_t kSmallBytes = 4096;  ///< such commands never wait for other clients
/// Larger commands of all connections that are not answered yet.
inline constexpr std::size_t kBytesUnderWay = 64U << 20U;
inline constexpr std::size_t kLineBytes = 32U << 10U;   ///< lines that are cut into tokens at once
inline constexpr std::size_t kSetUpBytes = 1U << 20U;   ///< of a program
inline constexpr std::size_t kHeadBytes = 16U << 10U;   ///< of a text that is to be recognised
inline constexpr std::size_t kAnswerBytes = 6U << 20U;  ///< a larger answer is refused
inline constexpr std::size_t kDiagnostics = 1000;       ///< of `check`; the rest is counted
inline constexpr std::size_t kEditBytes = kTextBytes;   ///< of edits of features
inline constexpr double kAsideSeconds = 5;  ///< of computing for a check or a curve of speeds
inline constexpr double kSlowSeconds = 30;  ///< of computing for what keeps a machine busy
inline constexpr std::size_t kConnections = 256;
inline constexpr std::size_t kMachines = 256;
inline constexpr int kStatesPerSecond = 20;
inline constexpr int kStalledSeconds = 10;  ///< a client that takes nothing for so long is closed
inline constexpr int kSilentSeconds = 3;    ///< without a word from who sends pings: he is away
inline constexpr int kLateMs = 2000;        ///< a dated command that is older is not carried out
inline constexpr int kRequestSeconds = 10;  ///< the operator has to refuse a request within them
static_assert(kAnswerBytes + kMessageBytes < kQueueBytes, "one answer never closes a connection");
}  // namespace limits

/// A command of the panel. The table of them is the protocol: arguments are checked against it and
/// its page is made from it. Keys of the panel are rows of machine::operation_table().
struct Command {
  enum class Who : std::uint8_t {
    anyone,   ///< who is connected
    watcher,  ///< who watches a machine
    op        ///< who operates the machine that he watches
  };

  std::string_view name;
  Who who = Who::anyone;
  std::vector<Argument> arguments;
  std::string sentence;                              ///< what it does
  std::string_view answer{};                         ///< keys of the answer besides id and ok
  const machine::OperationRow* operation = nullptr;  ///< null: it is no key of the panel
};

[[nodiscard]] const std::vector<Command>& commands();
/// Null: there is no such command.
[[nodiscard]] const Command* find_command(std::string_view name);

}  // namespace kerf::server
