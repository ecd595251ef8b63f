O1 (CALL-4: only N and a slash stand before G65)
/N10 G65 P2 A1.
M30
O2
#100=#1 (expect #100=1)
M99
