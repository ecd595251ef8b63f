(run with: --param MFZ=0)
O1 (MFZ: with 0 nothing is normalised)
#1=SIN[0.0000001]
IF[#1GT0]THEN #100=1 (expect #100=1)
M30
