O1 (EXP-12: the same function outside of an address)
#1=1.2345
#100=ROUND[#1] (expect #100=1)
G90 G00 X[ROUND[#1]]
#101=#5001 (expect #101=1.235)
X#100 (expect moves: rapid X1)
M30
