O1 (EXP-13: arguments are macro context)
G65 P2 X[ROUND[1.2345]]
M30
O2
#100=#24 (expect #100=1)
M99
