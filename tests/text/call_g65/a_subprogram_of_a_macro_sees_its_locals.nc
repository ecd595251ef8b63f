O1 (CALL-10: M98 keeps the level)
#1=1
G65 P2 A2.
#101=#1 (expect #101=1)
M30
O2
M98 P3
M99
O3
#100=#1 (expect #100=2)
M99
