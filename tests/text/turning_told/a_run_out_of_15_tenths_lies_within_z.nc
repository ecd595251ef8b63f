(run with: --machine lathe2 --param 5140=0.5 --param 5141=0)
O1 (Pecks and threads)
G97S500M03
G00X30.Z5.
G76P011560Q500R0
G76X28.Z-25.P1000Q1000F2. (expect moves: rapid X28 Z4.4226; thread X28 Z-22; thread X30 Z-23; rapid X30 Z5; rapid X28 Z4.4226; thread X28 Z-22; thread X30 Z-23; rapid X30 Z5)
M30
