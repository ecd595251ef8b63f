(run with: --machine lathe3c)
O1 (Holes)
G98S300M03
G00X80.Z-10.C0
G88X40.R-10.F100 (expect moves: rapid X60; line X40; line X60; rapid X80)
G89X50.R-10.F100 (expect moves: rapid X60; line X50; line X60; rapid X80)
M30
