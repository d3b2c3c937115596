#include "gate.h"

/// Exits with the number of wrong answers.
int main() {
  pleura::SFBool open;
  pleura::SFFloat in;
  Gate gate;
  open.route(gate);
  in.route(gate);
  int wrong = 0;
  in.setValue(3);
  wrong += gate.getValue() != 0;
  open.setValue(true);
  wrong += gate.getValue() != 3;
  in.setValue(4);
  wrong += gate.getValue() != 4;
  return wrong;
}
