O1 (section 10: R and Z in work coordinates)
#5223=-100.
G90 G00 Z10. (expect moves: rapid Z-90)
G99 G81 X1. Z-5. R2. F100 (expect moves: rapid X1 Z-90; rapid Z-98; line Z-105; rapid Z-98)
G80
M30
