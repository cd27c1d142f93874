#include "app/command.h"

int main(int argc, char** argv) { return glint::runCommandLine(argc, argv); }
