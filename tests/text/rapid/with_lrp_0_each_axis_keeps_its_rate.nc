(run with: --param LRP=0)
O1 (section 8.1: G00, LRP)
G00 X10. Y1. (expect moves: rapid X10 Y1 nonlinear)
G60 X20. (expect moves: rapid X20 nonlinear)
G99 G81 X30. Z-5. R2. F500 (expect moves: rapid X30 nonlinear; rapid Z2 nonlinear; line Z-5; rapid Z2 nonlinear)
M30
