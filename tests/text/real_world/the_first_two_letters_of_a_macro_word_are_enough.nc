O1 (WH, EN and GO)
#1=0
WH[#1LT3]DO1
#1=#1+1
EN1
GO 10
#100=1
N10 #101=#1 (expect #100=null, #101=3)
M30
