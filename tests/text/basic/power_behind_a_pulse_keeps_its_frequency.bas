pulse(1,1); power(20)
burn(0.1)
' (finally records: power 50 at 500 Hz; power 20 at 500 Hz; power 20 at 500 Hz; dwell 0.1; power 0 at 500 Hz; end)
