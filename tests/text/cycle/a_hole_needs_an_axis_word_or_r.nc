O1 (section 10: Z alone drills at the same place)
G90 G00 X3. Z10.
G99 G81 Z-5. R2. F100 (expect moves: rapid Z2; line X3 Z-5; rapid Z2)
Z-6. (expect moves: line X3 Z-6; rapid Z2)
G80
M30
