O1 (CALL-7: X#5 passes the value of #5)
#5=10
G65 P2 X#5 Y[#5+1] Z[7]
M30
O2
#100=#24 (expect #100=10)
#101=#25 (expect #101=11)
#102=#26 (expect #102=7)
M99
