O1 (tables in common variables)
#111=120
#125=7
#126=101
#100=#[#111+5] (expect #100=7)
#[#[#111+6]]=8 (expect #101=8)
#102=#[#[#111+6]]*2 (expect #102=16)
M30
