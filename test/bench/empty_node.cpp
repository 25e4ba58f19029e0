// A node without a task: what roscpp's start and end take. See bench_launch.

#include <ros/ros.h>

int main(int argc, char** argv) {
  ros::init(argc, argv, "empty_node");
  const ros::NodeHandle node;
  return 0;
}
