#include <pleura/x3d/browser/scene/scene.h>

/// Runs a scene for a tick; exits with 0 when it had no fault.
int main(int, char** arguments) {
  pleura::Scene scene;
  scene.load(arguments[1]);
  scene.tick(1);
  return scene.diagnostics().errors() > 0 || scene.document().nodes.empty() ? 1 : 0;
}
