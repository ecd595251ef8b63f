speed(10); power(50)
line(5,0); pulse(1,1); line(10,0)
' (finally records: power 50; power 50; line X5 Y0 Z0 F600; power 50 at 500 Hz; line X10 Y0 Z0 F600; power 0 at 500 Hz; end)
