#include <exception>
#include <stdexcept>

#include <fmt/format.h>

#include <pleura/fields/errors.h>
#include <pleura/nodes/core/plugin.h>
#include <pleura/x3d/browser/commands/commands.h>

namespace {

int fail(int status, const char* message) {
  if (*message != '\0') fmt::print(stderr, "pleura: {}\n", message);
  return status;
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app{"Pleura: X3D scenes of anatomy that breathes"};
  app.require_subcommand(1);
  app.set_version_flag("--version",
                       fmt::format("pleura {}, plugin ABI {}", PLEURA_VERSION, pleura::kPluginAbi));
  pleura::addRunCommand(app);
  pleura::addRenderCommand(app);
  pleura::addPlayCommand(app);
  pleura::addCheckCommand(app);
  pleura::addConvertCommand(app);
  pleura::addAnatomyCommand(app);
  pleura::addNodesCommand(app);
  pleura::addDemoCommand(app);
  pleura::addTradeoffCommand(app);
  try {
    app.parse(argc, argv);
  } catch (const CLI::Success& answered) {  // --help, --version
    return app.exit(answered);
  } catch (const CLI::ParseError& error) {
    app.exit(error);
    return pleura::kUsage;
  } catch (const pleura::UsageError& error) {
    return fail(pleura::kUsage, error.what());
  } catch (const std::invalid_argument& error) {
    return fail(pleura::kUsage, error.what());
  } catch (const std::bad_alloc&) {
    return fail(pleura::kFault, "out of memory");
  } catch (const std::exception& error) {
    return fail(pleura::kFault, error.what());
  }
  return pleura::kDone;
}
