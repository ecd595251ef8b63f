O1 (CYC-6: to R at feed, then rapid to the initial level)
G90 G00 Z50.
G98 G85 X0 Y0 Z-10. R2. F100 (expect moves: rapid Z2; line Z-10 F100; line Z2 F100; rapid Z50)
G80
M30
