(run with: --set #1003=1)
O1 (section 3.1: inputs and outputs by name)
#100=[#_UI[3]] (expect #100=1)
[#_UO[2]]=1
#101=#1102 (expect #101=1)
M30
