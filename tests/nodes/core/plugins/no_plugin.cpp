extern "C" int breathe() { return 12; }
