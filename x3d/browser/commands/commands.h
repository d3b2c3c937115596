#pragma once

#include <stdexcept>

#include <CLI/CLI.hpp>

namespace pleura {

/// What a command ends with.
enum ExitStatus { kDone = 0, kFault = 1, kUsage = 2 };

/// The scene or the data is at fault, and the faults have been told.
struct Fault : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// The command was called in a way that makes no sense.
struct UsageError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

// Each adds its subcommand, which throws when it fails.
void addAnatomyCommand(CLI::App& app);
void addCheckCommand(CLI::App& app);
void addConvertCommand(CLI::App& app);
void addNodesCommand(CLI::App& app);
void addPlayCommand(CLI::App& app);
void addRenderCommand(CLI::App& app);
void addRunCommand(CLI::App& app);
void addDemoCommand(CLI::App& app);
void addTradeoffCommand(CLI::App& app);

}  // namespace pleura
