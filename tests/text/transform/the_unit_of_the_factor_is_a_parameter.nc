(run with: --param SCR=0)
O1 (SCR 0: P200000 is 2)
G51 X0 Y0 P200000
G90 G00 X3. (expect moves: rapid X6)
G50
M30
