(run with: --param NAT=1)
O1 (NAT 1: -180 to 180)
#100=ATAN[-1]/[-1] (expect #100=-135)
#101=ATAN[1]/[-1] (expect #101=135)
M30
