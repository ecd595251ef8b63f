(run with: --set #11001=100)
O1 (section 8: G43 before the motion)
G90 G00 Z10. G43 H1
#100=#5023 (expect #100=110)
M30
