O1 (PS1099: outputs are 0 to 15)
[#_UO[16]]=1 (expect alarm PS1099)
M30
