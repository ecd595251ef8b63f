O1 (G10-1: 10 and then 1 more)
G90 G10 L2 P1 X10.
G91 G10 L2 P1 X1.
#100=#5221 (expect #100=11)
#101=#2501 (expect #101=11)
M30
