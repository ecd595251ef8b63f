(run with: --param 6050=12)
O1 (CODE-3: X10. is #24, I5. is #4, N may stand before)
N5 G12 X10. I5. A1000
M30
O9010
#100=#24 (expect #100=10)
#101=#4 (expect #101=5)
#102=#1 (expect #102=1)
M99
(finally moves: none)
