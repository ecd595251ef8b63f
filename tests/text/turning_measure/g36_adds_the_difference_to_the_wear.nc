(run with: --machine lathe2 --skip-at X=50.4)
O1 (Measuring tools)
G00X100.Z5.T0101
G36X50. (expect moves: rapid X70; probe X50.4)
#100=#2001
G00X60. (expect moves: rapid X60)
#101=#5021
M30
(finally #100=0.4, #101=60.4)
