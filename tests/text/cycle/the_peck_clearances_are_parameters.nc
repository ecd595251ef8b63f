(run with: --param d_G73=0.5 --param d_G83=2)
O1 (CYC-3, CYC-4: half a millimetre and two)
G90 G00 Z10.
G99 G73 X0 Y0 Z-8. R0 Q4. F100 (expect moves: rapid Z0; line Z-4; rapid Z-3.5; line Z-8; rapid Z0)
G83 Z-8. R0 Q4. (expect moves: line Z-4; rapid Z0; rapid Z-2; line Z-8; rapid Z0)
G80
M30
