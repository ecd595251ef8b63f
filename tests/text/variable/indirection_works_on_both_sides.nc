O1 (VAR-5: #[#1+1] is written and read)
#1=100
#[#1+1]=3 (expect #101=3)
#102=#[#1+1]*2 (expect #102=6)
M30
