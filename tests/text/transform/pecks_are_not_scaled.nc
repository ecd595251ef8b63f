(run with: --param 5115=1)
O1 (levels are scaled, the peck Q and the clearance d are not)
G90 G00 X0 Y0 Z5.
G51 X0 Y0 Z0 P2000
G99 G83 Z-5. R1. Q4. F100 (expect moves: rapid Z2; line Z-2; rapid Z2; rapid Z-1; line Z-6; rapid Z2; rapid Z-5; line Z-10; rapid Z2)
G80
M30
