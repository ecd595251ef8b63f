(run with: --decimal-point calculator)
O1 (CALL-7: with DPI 1 X10 passes 10)
G65 P2 X10
M30
O2
#100=#24 (expect #100=10)
M99
