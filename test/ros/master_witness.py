"""A ROS master that remembers who registered what."""

import threading
import xmlrpc.client
from xmlrpc.server import SimpleXMLRPCRequestHandler, SimpleXMLRPCServer
from socketserver import ThreadingMixIn

import rosgraph


class _Handler(SimpleXMLRPCRequestHandler):
    protocol_version = 'HTTP/1.1'

    def log_message(self, *_):
        pass


class _Server(ThreadingMixIn, SimpleXMLRPCServer):
    daemon_threads = True


class MasterWitness:
    """Passes every call on to the real master. Unlike a look at the master's state, it misses
    nothing that comes and goes. A program uses it when started with `environment`."""

    def __init__(self):
        self._server = _Server(('localhost', 0), requestHandler=_Handler, logRequests=False)
        self._server.register_instance(self)
        self._thread = threading.Thread(target=self._server.serve_forever, daemon=True)
        self._topics = {'registerPublisher': set(), 'registerSubscriber': set()}
        self._news = threading.Condition()
        self.environment = {'ROS_MASTER_URI':
                            'http://localhost:{}/'.format(self._server.server_address[1])}

    def __enter__(self):
        self._thread.start()
        return self

    def __exit__(self, *_):
        self._server.shutdown()
        self._server.server_close()

    def _dispatch(self, method, arguments):
        answer = getattr(xmlrpc.client.ServerProxy(rosgraph.get_master_uri()), method)(*arguments)
        with self._news:
            if method in self._topics:
                self._topics[method].add(arguments[1])
            self._news.notify_all()
        return answer

    def published(self):
        with self._news:
            return set(self._topics['registerPublisher'])

    def subscribed(self):
        with self._news:
            return set(self._topics['registerSubscriber'])

    def wait_for_subscriber(self, topic, timeout):
        with self._news:
            if not self._news.wait_for(lambda: topic in self._topics['registerSubscriber'],
                                       timeout):
                raise AssertionError('nobody subscribed to ' + topic)
