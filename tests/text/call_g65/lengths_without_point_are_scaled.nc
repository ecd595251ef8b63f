O1 (CALL-7: X10 passes 0.010, X10. passes 10)
G65 P2 X10 Y10. H5 D3
M30
O2
#100=#24 (expect #100=0.01)
#101=#25 (expect #101=10)
#102=#11 (expect #102=5)
#103=#7 (expect #103=3)
M99
