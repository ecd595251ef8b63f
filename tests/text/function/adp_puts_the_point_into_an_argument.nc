O1 (section 4.2: X10 was passed as 0.010)
G65 P2 X10
M30
O2
#100=#24 (expect #100=0.01)
#101=ADP[#24] (expect #101=10)
M99
