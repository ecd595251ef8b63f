O1 (assigning #0 in a loop)
#101=1
#102=2
#103=3
#1=101
WHILE[#1LE103]DO1
#[#1]=#0
#1=#1+1
END1
#100=1 (expect #101=null, #102=null, #103=null)
M30
