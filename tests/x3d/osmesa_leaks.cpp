/// OSMesa keeps some of what it allocates for a context after that is destroyed: the leak is not ours.
extern "C" const char* __lsan_default_suppressions();  // NOLINT(bugprone-reserved-identifier)
extern "C" const char* __lsan_default_suppressions() { return "leak:libOSMesa\n"; }
