(run with: --param NAT=1)
O1 (NAT 1: ASIN is signed)
#100=ASIN[0.5] (expect #100=30)
#101=ASIN[-0.5] (expect #101=-30)
M30
