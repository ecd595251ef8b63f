(run with: --set #11001=100)
O1 (TLC-1: like G49)
G90 G43 H1 Z10.
H0 Z5.
#100=#5023 (expect #100=5)
M30
