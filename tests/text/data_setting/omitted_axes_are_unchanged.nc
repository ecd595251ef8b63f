O1 (G10-2: only X is written)
G90 G10 L2 P1 X1. Y2.
G10 L2 P1 X5.
#100=#5221 (expect #100=5)
#101=#5222 (expect #101=2)
M30
