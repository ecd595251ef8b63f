O1 (CALL-6: before the new level exists)
#1=3
G65 P2 A[#1+1] B-#1
M30
O2
#100=#1 (expect #100=4)
#101=#2 (expect #101=-3)
M99
