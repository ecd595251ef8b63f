(run with: --param 6050=12)
O1 (CODE-3: the locals of the caller are untouched)
#1=9
G12 A1.
#101=#1 (expect #101=9)
M30
O9010
#1=#1+1
#100=#1 (expect #100=2)
M99
