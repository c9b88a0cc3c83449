/* The smallest program: linked by the C compiler with the whole core and no C++ runtime library. */
int main(void) {
  return 0;
}
